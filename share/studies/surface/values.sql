-- Contact values of the calibrated rocks with their 95 % intervals; in bold those outside of the interval that an earlier design of the rock's own had.
WITH value AS (SELECT new.rowid AS nth, new.rock, new.parameter || iif(instr(new.value, ' '), ', ' || substr(new.value, instr(new.value, ' ') + 1), '') AS parameter,
                      CAST(new.value AS REAL) AS value, CAST(new.interval AS REAL) AS low, CAST(substr(new.interval, instr(new.interval, ' to ') + 4) AS REAL) AS high,
                      new.interval LIKE '% to %' AS determined,
                      old.interval LIKE '% to %' AND NOT CAST(new.value AS REAL) BETWEEN CAST(old.interval AS REAL) AND
                          CAST(substr(old.interval, instr(old.interval, ' to ') + 4) AS REAL) AS outside
               FROM new LEFT JOIN old USING (rock, parameter) WHERE new.parameter NOT LIKE 'rock.%')
SELECT replace(replace(parameter, 'contact.', ''), '_', ' ') AS parameter, rock,
       iif(outside, '**', '') || text('{:.4g}', value) || iif(outside, '**', '') || iif(determined, text(' ({:.4g} to {:.4g})', low, high), '')
FROM value ORDER BY nth
