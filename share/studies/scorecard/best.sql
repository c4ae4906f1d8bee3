-- The best sets of the design: factors, and what is expected of them.
SELECT boundary_energy AS "boundaries, J/m²", crystal_over_boundary AS "crystals over that", bridging_strength AS "σb/tc", bridging_energy AS "Gb, 79 J/m²", open, strength_modulus AS modulus,
    strength AS "tc, 7.54 MPa", young_modulus AS "E, GPa", rows, UCS_after_300 AS "UCS after 300 °C", onset AS "onset, °C", CI_by_10_percent_lost_over_UCS AS "CI, 10 % lost", K_IC FROM chosen LIMIT 5
