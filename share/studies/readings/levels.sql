-- σt of discs against tc, for --pivot: one row per variant.
WITH discs AS (
    SELECT variant, contact_tensile_strength_MPa AS tc, mean(tensile_strength_MPa) AS bts, min(runs.rowid) AS place,
        text('{:.1f} ({:.1f}–{:.1f})', mean(tensile_strength_MPa), min(tensile_strength_MPa), max(tensile_strength_MPa)) AS entry
    FROM runs JOIN strength USING (file) WHERE test = 'brazilian' GROUP BY variant, tc
), entries AS (
    SELECT variant, text('σt at tc {}, MPa', tc) AS heading, entry, tc, place FROM discs
    UNION ALL SELECT variant, 'd ln σt/d ln tc', ifnull(text('{:.2f}', exponent(tc, bts)), '-'), 1e9, min(place)
    FROM discs GROUP BY variant
)
SELECT variant, heading, entry FROM entries ORDER BY tc, place
