-- The claims of the studies, one row a claim: at the paper's microparameters, at ours, and with minerals at the paper's. An explanation of a
-- further point is told if it is another one.
WITH rows AS (
    SELECT 1 AS point, rowid AS place, * FROM theirs
    UNION ALL SELECT 2, rowid, * FROM ours
    UNION ALL SELECT 3, rowid, * FROM minerals
), claims AS (
    SELECT study, claim, min(1e6 * point + place) AS place FROM rows WHERE claim IS NOT NULL GROUP BY study, claim
), joined AS (
    SELECT claims.*, coalesce(theirs.paper, ours.paper, minerals.paper) AS paper, theirs.ours AS "at_the_paper's_point", theirs.difference, theirs.verdict,
        ours.ours AS at_our_point, ours.difference AS our_difference, ours.verdict AS our_verdict, minerals.ours AS with_minerals,
        minerals.difference AS their_difference, minerals.verdict AS their_verdict, theirs.explanation AS first, ours.explanation AS second,
        minerals.explanation AS third
    FROM claims LEFT JOIN theirs USING (study, claim) LEFT JOIN ours USING (study, claim) LEFT JOIN minerals USING (study, claim)
)
SELECT study, claim, paper, "at_the_paper's_point", difference, verdict, at_our_point, our_difference, our_verdict, with_minerals, their_difference,
    their_verdict, coalesce(first, second, third) || iif(second <> first, '; at our point: ' || second, '') ||
        iif(third <> coalesce(first, second) OR second <> first, '; with minerals: ' || third, '') AS explanation
FROM joined ORDER BY place
