-- The judgements of a rock: mean with its interval beside the range.
SELECT row, judgement, text('{:.0f}', n) AS n, text('{:.2f} ({:.2f} to {:.2f})', mean, least, most) AS ours,
    CASE WHEN high IS NULL THEN text('≥ {:.2f}', low) ELSE text('{:.2f}–{:.2f}', low, high) END AS range, iif(verdict = 'in', '**in**', verdict) AS verdict
FROM scorecard WHERE rock = :ROCK ORDER BY scorecard.rowid
