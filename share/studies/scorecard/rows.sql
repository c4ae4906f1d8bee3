-- The verdict of each row of the scorecard: in if all its judgements are, out if one is, else open.
SELECT variant, row, CASE WHEN total(verdict = 'out') THEN 'out' WHEN total(verdict = 'open') THEN 'open' ELSE 'in' END AS verdict,
    entries(judgement || ' ' || text('{:.2f} ({:.2f} to {:.2f})', mean, least, most)) AS judgements
FROM scorecard GROUP BY variant, row ORDER BY variant, CAST(row AS REAL)
