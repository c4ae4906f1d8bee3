-- One row per variant and size of specimen: toughness beside what a strip-yield zone makes of √(Ẽ G) at this size, the bridged zone at the
-- largest load, and the share of the crack that runs within crystals; mean ± half of the 95 % interval of the mean.
SELECT variant, series AS specimens, count(*) AS n, mean(K) AS K, half_interval(K) AS K_half, mean(strip_yield_K) AS strip_yield_K,
    mean(front_mm) AS front_mm, mean(zone_mm) AS zone_mm, half_interval(zone_mm) AS zone_half_mm, mean(zone_width_mm) AS zone_width_mm, half_interval(zone_width_mm) AS zone_width_half_mm,
    total(crack_mm) AS crack_mm, total(cut_mm) / total(crack_mm) AS cut_share
FROM zones GROUP BY variant, series ORDER BY min(zones.rowid)
