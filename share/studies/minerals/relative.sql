-- For --pivot: strengths of :POINT over the mean of their series without contrast; the tests of a series are of one kind, at one point.
WITH tests AS (
    SELECT *, ifnull(tensile_strength_MPa, peak_compressive_stress_MPa) AS strength FROM strength JOIN runs USING (file)
), uniform AS (
    SELECT series, mean(strength) AS uniform FROM tests WHERE contrast = 0 GROUP BY series
)
SELECT file, contrast, replace(replace(series, :POINT || ': ', ''), ' ', '_') || '_over_that_without_contrast', strength / uniform
FROM tests LEFT JOIN uniform USING (series) WHERE point = :POINT AND contrast >= 0
