-- Load of 50 mm of thickness, N, and opening of the mouth, µm: the stress of the history is over the length of the beam.
SELECT history.time_s, 1e6 * elongation_m AS cmod_um, -axial_stress_Pa * 3.125e-3 * :DEPTH * 0.05 AS load_N
FROM history JOIN mouth USING (step)
