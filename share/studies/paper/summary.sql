-- Numbers of verdicts by study and point.
WITH verdicts AS (
    SELECT rowid AS place, study, 1 AS nth, 'the paper''s' AS point, verdict FROM claims
    UNION ALL SELECT rowid, study, 2, 'ours', our_verdict FROM claims
    UNION ALL SELECT rowid, study, 3, 'with minerals', their_verdict FROM claims
)
SELECT study, point, count(*) AS claims, count(*) FILTER (WHERE verdict = 'holds') AS holds, count(*) FILTER (WHERE verdict = 'open') AS open,
    count(*) FILTER (WHERE verdict = 'differs') AS differs
FROM verdicts WHERE verdict IS NOT NULL GROUP BY study, nth ORDER BY min(min(place)) OVER (PARTITION BY study), nth
