-- From share/results/great-cell.tsv, for README.md: the largest difference from each reference (root mean square) by the elements round the rim, the
-- worse of the loads; beside the joint on the finer mesh. Closed forms have a circular outline, all others a polygon.
SELECT "case", rock, outline, joint, replace(beside, ' (computed here)', '') AS beside,
    text('{:.2f} ({:.2f})', max(largest_off) FILTER (WHERE around = 128), max(rms_off) FILTER (WHERE around = 128)) AS '128',
    text('{:.2f} ({:.2f})', max(largest_off) FILTER (WHERE around = 256), max(rms_off) FILTER (WHERE around = 256)) AS '256',
    max(near_joint_off) FILTER (WHERE around = 256) AS 'nearer'
FROM great_cell WHERE outline = 'polygon' OR beside = 'closed form'
GROUP BY "case", rock, outline, joint, beside
ORDER BY "case", beside NOT LIKE 'closed%', beside NOT LIKE 'ref%', rock DESC, beside
