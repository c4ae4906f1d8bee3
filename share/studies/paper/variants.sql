-- From share/results/paper-variants.tsv, for README.md: strengths by the variants of the law that the programs have.
SELECT variant, [σt, MPa] AS σt, [UCS, MPa] AS UCS, [σ1 at 8 MPa, MPa] AS [σ1 at 8 MPa], [d ln σt/d ln tc]
FROM variants WHERE variant IN ('the paper', 'literal', 'consistent', 'consistent-tc', 'consistent-cc') ORDER BY rowid
