-- For --pivot: criteria (energies: those of `brittle`, bridges: of `toughness`, quantities: all means of `toughness`) over chosen variants, beside their ranges: means ± half of
-- their 95 % intervals, bold within the range. What counts when 10 % is lost is compared alone.
WITH chosen(place, variant) AS (VALUES (1, 'tough'), (2, 'g30-400'), (3, 'brittle'), (4, 'open35-0.05'), (5, 'bridge0.55-2')),
headings(nth, criterion, heading) AS (VALUES (1, 'CI by gauges', 'CI by crack strain'), (2, 'CI by count', 'CI by 1 % of cracks'), (3, 'lost', 'the same, 10 % lost'),
    (4, 'CD', 'CD by volume'), (5, 'direct / Brazilian', 'direct / Brazilian'), (6, 'K_IC', 'K_IC, MPa√m')),
criteria AS (
    SELECT variant, criterion, mean, half_interval, low, high FROM energies UNION ALL SELECT variant, criterion, mean, half_interval, low, high FROM bridges
    UNION ALL SELECT variant, 'lost', mean, half_interval, 0.35, 0.55 FROM quantities WHERE quantity = 'CI_by_10_percent_lost_over_UCS'
), shown AS (
    SELECT criterion, low, high, place, variant, text(CASE WHEN mean BETWEEN low AND high THEN '**{:.2f} ± {:.2f}**' ELSE '{:.2f} ± {:.2f}' END, mean, half_interval) AS value
    FROM criteria JOIN chosen USING (variant)
    UNION ALL SELECT DISTINCT criterion, low, high, 0, 'range', text('{}–{}', low, high) FROM criteria
)
SELECT heading AS criterion, variant, value FROM shown JOIN headings USING (criterion) ORDER BY nth, place
