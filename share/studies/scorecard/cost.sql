-- What each kind of test costs, seconds of one processor: runs, median of one, all.
SELECT series, count(*) AS runs, round(median(wall_time_s), 1) AS median_s, round(total(wall_time_s)) AS all_s FROM runs JOIN strength USING (file) GROUP BY series ORDER BY min(runs.rowid)
