-- What share/doc/speed.md shows of the tables in share/results/benchmark: the widest instruction set of each processor, scaled masses (the default),
-- of even grains real ones too.
SELECT machine, instruction_set, [case], masses, iif(threads = 1, '1 thread', text('{:.0f}', threads)), text('{:.1f}', ns)
FROM benchmark
WHERE (masses = 'selective' OR [case] = 'even-1122') AND instruction_set = (SELECT max(other.instruction_set) FROM benchmark AS other WHERE other.machine = benchmark.machine AND other.instruction_set <> 'plain')
ORDER BY threads, benchmark.rowid
