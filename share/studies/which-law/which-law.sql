-- For --pivot: what new specimens of each model have, from targets.tsv and tests.tsv. Within the bound of the laboratory's value in bold, undecided
-- with a question mark; those quantities that README.md shows.
WITH of_models AS (SELECT model, min(rowid) AS place FROM targets GROUP BY model),
measured AS (
    SELECT targets.rowid AS nth, CASE target WHEN 'K_IC' THEN target ELSE replace(target, '_', ' ') END AS quantity, ifnull(text('{:.4g}', laboratory), '') AS laboratory, model,
        text('{:.3g}', new_specimens) AS value, ifnull(text(' ± {:.2g}', (high - low) / 2), '') AS half, ifnull(verdict, '') AS verdict
    FROM targets
),
means AS (SELECT model, target, new_specimens AS mean FROM targets),
ratios(nth, quantity, above, below, laboratory) AS (VALUES
    (1001, 'direct / Brazilian', 'direct_tensile_strength', 'Brazilian_strength', '0.65 to 0.9'),
    (1002, 'crack initiation / UCS', 'crack_initiation', 'UCS', '0.35 to 0.55'),
    (1003, 'crack initiation by count / UCS', 'crack_initiation_by_count_of_cracks', 'UCS', '0.35 to 0.55'),
    (1004, 'crack damage / UCS', 'crack_damage', 'UCS', '0.65 to 0.95')),
rows AS (
    SELECT nth, quantity, laboratory, model, CASE verdict WHEN 'within' THEN '**' || value || '**' || half
        WHEN 'undecided' THEN value || half || ' ?' ELSE value || half END AS entry FROM measured
    UNION ALL SELECT nth, quantity, laboratory, a.model, text('{:.2f}', a.mean / b.mean) FROM ratios
        JOIN means AS a ON a.target = above JOIN means AS b ON b.target = below AND b.model = a.model
    UNION ALL SELECT 1005, 'scatter of UCS, %', '', model, text('{:.0f}', 100 * deviation(first_peak_MPa) / mean(first_peak_MPa))
        FROM tests WHERE test = 'uniaxial' GROUP BY model
    UNION ALL SELECT 1006, 'first peaks at 8 MPa', '', model, text('{:.0f} of {:.0f}', count(first_peak_MPa), count(*))
        FROM tests WHERE test = 'triaxial' AND confining_pressure_MPa = 8 GROUP BY model
    UNION ALL SELECT 1007, 'grains × steps of a uniaxial test, millions', '', model, text('{:.0f}', mean(grains * steps) / 1e6) FROM tests WHERE test = 'uniaxial' GROUP BY model
    UNION ALL SELECT 0, 'ended', '', model, entries(ended) FROM targets GROUP BY model
),
ordered AS (SELECT min(nth) AS first, quantity FROM rows GROUP BY quantity)
SELECT quantity, rows.laboratory, model, entry FROM rows JOIN ordered USING (quantity) JOIN of_models USING (model)
WHERE quantity IN ('ended', 'UCS', 'first peak at 8 MPa', 'first peak at 20 MPa', 'K_IC', 'drop behind the first peak at 8 MPa') OR first > 1000 AND quantity NOT IN ('first peaks at 8 MPa', 'crack initiation / UCS')
ORDER BY first, place
