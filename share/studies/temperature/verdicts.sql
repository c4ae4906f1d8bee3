-- The criteria of heated granite-crystals by their verdict.
SELECT replace(verdict, ', mean inside', '') AS verdict, entries(criterion || ' ' || text(CASE WHEN criterion LIKE 'onset%' THEN '{:.0f} ({:.0f}–{:.0f})' ELSE '{:.2f} ({:.2f}–{:.2f})' END,
    value, least, most)) AS 'criteria, ours'
FROM temperature_judged WHERE question = 'heat' AND rock = 'granite-crystals' GROUP BY 1 ORDER BY min(temperature_judged.rowid)
