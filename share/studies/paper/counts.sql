-- For --pivot, from share/results/paper-summary.tsv, for README.md: how many claims of each study hold, are open and differ at each point.
SELECT study, point, text('{:.0f}, {:.0f}, {:.0f}', holds, open, differs) FROM summary ORDER BY rowid
