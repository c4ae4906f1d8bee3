-- Strengths of the same specimens at several rates, for --pivot: the mean at the slowest, and changes from it in per cent.
WITH tests AS (
    SELECT seed, rate_tolerance AS rate, peak_compressive_stress_MPa AS ucs FROM rated
), changes AS (
    SELECT tests.rate, 100 * (tests.ucs / slowest.ucs - 1) AS change FROM tests JOIN tests AS slowest USING (seed)
    WHERE slowest.rate = (SELECT min(rate) FROM tests) AND tests.rate > slowest.rate
)
SELECT 'specimens', count(DISTINCT seed) FROM tests
UNION ALL SELECT text('UCS at {}, MPa', rate), mean_and_half(ucs, '.1f') FROM tests WHERE rate = (SELECT min(rate) FROM tests)
UNION ALL SELECT text('at {}, %', rate), mean_and_half(change, '+.1f') FROM changes GROUP BY rate
