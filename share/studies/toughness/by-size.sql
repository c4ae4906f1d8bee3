-- For --pivot: K_IC by the diameter of half-discs, in mm; at 80 mm also what strip yield makes of √(Ẽ G), and the crack's share within crystals.
WITH diameters(nth, specimens, heading) AS (VALUES (1, 'half-disc R25', 'Ø 50'), (2, 'half-disc 0.5', 'Ø 80'), (3, 'half-disc R75', 'Ø 150'), (4, 'half-disc R150', 'Ø 300')),
sized AS (SELECT rowid AS place, * FROM sizes WHERE variant IN (SELECT variant FROM sizes WHERE specimens = 'half-disc R25')),
shown AS (
    SELECT place, nth, variant, heading, coalesce(text('{:.2f} ± {:.2f}', K, K_half), text('{:.2f}', K)) AS value FROM sized JOIN diameters USING (specimens)
    UNION ALL SELECT place, 5, variant, 'strip yield', text('{:.2f}', strip_yield_K) FROM sized WHERE specimens = 'half-disc 0.5'
    UNION ALL SELECT place, 6, variant, 'within crystals, %', text('{:.0f}', 100 * cut_share) FROM sized WHERE specimens = 'half-disc 0.5'
)
SELECT variant, heading, value FROM shown ORDER BY nth, place
