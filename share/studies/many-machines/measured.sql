-- One row per run: what it counted and took, with the work of a grain on one rank, from which lib/rank-cost predicts it.
SELECT r.file, s.grains, r.ranks, r.ranks AS ranks_per_node, r.threads, :CORES AS cores, s.steps,
    d.digest = of_alone.digest AS same_bytes,
    text('{:.4g}', 1e9 * alone.wall_time_s / alone.steps / alone.grains) AS ns_per_grain, 10 AS steps_per_row,
    m.ghost_nodes, m.nodes_of_rank, m.neighbours, m.kB_a_step, m.messages_a_step, m.waited_percent,
    text('{:.4g}', 1e6 * s.wall_time_s / s.steps) AS step_us
FROM runs r JOIN strength s USING (file) JOIN digests d USING (file) LEFT JOIN messages m USING (file)
    JOIN runs a ON a.specimen = r.specimen AND a.ranks = 1 JOIN strength alone ON alone.file = a.file
    JOIN digests of_alone ON of_alone.file = a.file
ORDER BY r.rowid
