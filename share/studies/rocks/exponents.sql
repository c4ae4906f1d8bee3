-- For --pivot: exponents of the contact values in strengths of Augig and Wausau granite.
WITH parameters(nth, parameter, heading) AS (VALUES (1, 'contact.tensile_strength', 'tc'), (2, 'ratios.cohesion', 'cc / tc'),
    (3, 'contact.friction_angle', 'φ'), (4, 'contact.residual_friction_angle', 'residual φ')),
responses(place, response) AS (VALUES (1, 'Brazilian strength'), (2, 'UCS'), (3, 'first peak at 8 MPa'), (4, 'crack initiation'), (5, 'crack damage'))
SELECT rock, response, heading, text('{:.2f} ± {:.2f}', exponent, (exponent_high - exponent_low) / 2)
FROM rocks_identify JOIN parameters USING (parameter) JOIN responses USING (response)
WHERE rock IN ('Augig granite', 'Wausau granite') ORDER BY place, rock, nth
