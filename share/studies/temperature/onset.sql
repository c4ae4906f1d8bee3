-- When the cracks of 450 °C begin, °C, and their length over the area, mm/cm², a column for each rock.
WITH shown(nth, quantity, heading) AS (VALUES (2, 'onset_1_percent_C', '1 %, °C'), (4, 'cracks', 'all, mm/cm²'),
    (5, 'cracks_k_feldspar-quartz', 'K-feldspar–quartz'), (6, 'cracks_k_feldspar-plagioclase', 'K-feldspar–plagioclase'))
SELECT heading AS cracks, replace(replace(rock, '-calibrated', ''), '-', ' '), coalesce(text(CASE WHEN nth < 4 THEN '{:.0f} ± {:.0f}' ELSE '{:.1f} ± {:.1f}' END, mean, half_interval), text('{:.1f}', mean))
FROM temperature JOIN shown USING (quantity) WHERE part = 'heat' AND text('{}', state) = '450' ORDER BY nth, temperature.rowid
