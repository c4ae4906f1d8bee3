-- From share/results/paper-claims.tsv, for README.md: claims on strengths and on the cracks at the uniaxial peak.
SELECT claim, paper, [at_the_paper's_point], verdict, our_verdict AS ours, with_minerals, their_verdict AS verdict_with_minerals
FROM claims
WHERE claim IN ('Table 8: E', 'Table 8: σt', 'Table 8: UCS', 'Table 8: σ1 at 8 MPa, against the laboratory''s line', 'Fig 10: exponent of σt')
    OR claim LIKE '%uniaxial peak'
