-- From share/results/many-machines.tsv, for README.md: counts and times of a step, measured / predicted. Times only where each
-- thread had a core.
SELECT grains, ranks, CASE same_bytes WHEN 1 THEN 'yes' ELSE 'no' END AS same_bytes,
    text('{:.0f} / {:.0f}', 1.0 * ghost_nodes, 1.0 * predicted_ghost_nodes) AS ghost_nodes, text('{:.0f}', 1.0 * waited_percent) AS waited_percent,
    CASE WHEN ranks * threads <= cores THEN text('{:.0f} / {:.0f}', 1.0 * step_us, 1.0 * predicted_step_us) ELSE '-' END AS step_us
FROM many_machines
