-- The claims of the studies, one row a claim: at the paper's microparameters, at ours, and with minerals at the paper's. An explanation of a
-- further point is told if it is another one.
WITH rows AS (
    SELECT 1 AS point, rowid AS place, * FROM theirs
    UNION ALL SELECT 2, rowid, * FROM ours
    UNION ALL SELECT 3, rowid, * FROM minerals
), told AS (  -- a difference that is a bare number keeps its sign and its two digits
    SELECT *, iif(typeof(difference) = 'real', text('{:+.2f}', difference), difference) AS off FROM rows WHERE claim IS NOT NULL
), claims AS (
    SELECT study, claim, min(1e6 * point + place) AS place, max(paper) AS paper FROM told GROUP BY study, claim
), joined AS (
    SELECT claims.*, a.ours AS "at_the_paper's_point", a.off AS difference, a.verdict, b.ours AS at_our_point, b.off AS our_difference,
        b.verdict AS our_verdict, c.ours AS with_minerals, c.off AS their_difference, c.verdict AS their_verdict,
        a.explanation AS first, b.explanation AS second, c.explanation AS third
    FROM claims LEFT JOIN told AS a ON a.point = 1 AND a.study = claims.study AND a.claim = claims.claim
        LEFT JOIN told AS b ON b.point = 2 AND b.study = claims.study AND b.claim = claims.claim
        LEFT JOIN told AS c ON c.point = 3 AND c.study = claims.study AND c.claim = claims.claim
)
SELECT study, claim, paper, "at_the_paper's_point", difference, verdict, at_our_point, our_difference, our_verdict, with_minerals, their_difference,
    their_verdict, coalesce(first, second, third) || iif(second <> first, '; at our point: ' || second, '') ||
        iif(third IS NOT NULL AND (third <> coalesce(first, second) OR second <> first), '; with minerals: ' || third, '') AS explanation
FROM joined ORDER BY place
