-- Predictions of lib/rank-cost for cases.tsv, for README.md.
SELECT "case", network, text('{:.0f} × {:.0f}', 1.0 * ranks, 1.0 * threads) AS ranks_and_threads,
    text('{:.3g}', work_us / 1000.0) AS work_ms, text('{:.2g}', waiting_us / 1000.0) AS waiting_ms,
    text('{:.2g}', (rows_us + updates_us) / 1000.0) AS rows_and_updates_ms, text('{:.3g}', predicted_step_us / 1000.0) AS step_ms,
    text('{:.0f}', 1.0 * efficiency_percent) AS efficiency_percent, text('{:.3g}', 1.0 * memory_GB_a_node) AS memory_GB_a_node, text('{:.2g}', 1.0 * test_h) AS test_h
FROM cost
