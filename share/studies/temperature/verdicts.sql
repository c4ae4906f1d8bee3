-- The criteria of heated granite, a column for each rock.
SELECT criterion, replace(replace(rock, '-calibrated', ''), '-', ' '),
    CASE WHEN criterion LIKE 'onset%' THEN text('{:.0f} ({:.0f}–{:.0f}): ', value, least, most) ELSE text('{:.2f} ({:.2f}–{:.2f}): ', value, least, most) END || verdict
FROM temperature_judged WHERE question = 'heat'
