-- For --pivot: the judgements of bounds.tsv of single specimens, those of two tests by specimens of one number.
WITH two(quantity, above, below) AS (
    VALUES ('UCS_over_Brazilian', 'UCS', 'Brazilian'), ('direct_over_Brazilian', 'direct', 'Brazilian'), ('UCS_after_300', 'UCS_300', 'UCS'), ('E_after_300', 'E_300', 'E')
)
SELECT variant, specimen, quantity, value FROM (
    SELECT variant, specimen, quantity, value FROM measured UNION ALL
    SELECT variant, a.specimen, two.quantity, a.value / b.value FROM two JOIN measured AS a ON a.quantity = above JOIN measured AS b USING (variant, specimen) WHERE b.quantity = below
) JOIN bounds USING (quantity) ORDER BY variant, specimen, bounds.rowid
