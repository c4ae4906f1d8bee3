-- Cracks and scatter of minerals.tsv, for --pivot: one row per variant, means with half of their intervals, coefficients of variation.
WITH shown(nth, quantities, heading, counted) AS (VALUES
    (1, 'CI_over_UCS', 'CI / UCS', ' ({})'),
    (2, 'CD_over_UCS', 'CD / UCS', ' ({})'),
    (3, 'tensile_share_by_sign', 'tensile by sign', ''),
    (4, 'tensile_share_by_traction', 'tensile by traction', '')
), varied(nth, quantities, heading) AS (VALUES
    (5, 'UCS_MPa', 'UCS'), (6, 'first_peak_at_%', NULL), (7, 'Brazilian_MPa', 'Brazilian')
), entries AS (
    SELECT nth, minerals.rowid AS place, variant, heading,
        coalesce(text('{:.2f} ± {:.2f}', mean, half_interval), text('{:.2f}', mean), '-') || iif(counted = '', '', text(counted, n)) AS entry
    FROM minerals JOIN shown ON quantity LIKE quantities
    UNION ALL SELECT nth, minerals.rowid, variant, text('c. v. of {}, %', ifnull(heading, replace(quantity, '_', ' '))),
        ifnull(text('{:.1f}', 100 * coefficient_of_variation), '-')
    FROM minerals JOIN varied ON quantity LIKE quantities
)
SELECT variant, heading, entry FROM entries ORDER BY nth, place
