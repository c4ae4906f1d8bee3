-- For --pivot: other definitions of the thresholds, and the cracks at the uniaxial peak, of the variants of :PART.
WITH shown(nth, quantities, heading) AS (VALUES
    (2, 'CD_2d_over_UCS', 'CD by 2D volume'),
    (3, 'tensile_share_by_traction', 'tensile by traction'), (4, 'tensile_share_by_sign', 'tensile by sign'),
    (5, 'share_of_cracks_between_crystals', 'between crystals'))
SELECT variant, heading, coalesce(text('{:.2f} ± {:.2f}', mean, half_interval), text('{:.2f}', mean))
FROM variants JOIN brittle USING (variant) JOIN shown ON quantity = quantities WHERE part = :PART ORDER BY variants.rowid, nth
