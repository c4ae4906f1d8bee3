#!/usr/bin/env python3
"""Contacts of a granite by GrainLearning, from the stress of one uniaxial test: python3 grainlearning.py CURVE.tsv

CURVE.tsv has the columns strain and stress_MPa, strain ascending from 0. Needs the package grainlearning (https://grainlearning.readthedocs.io),
with which this file is untried: its calls are those of its tutorial on models in Python. `curve_of` and `run_samples` do without it.
"""

import sys

import numpy as np

import graincrack

MATERIAL = "augig-granite-calibrated"
NAMES = ["contact_tensile_strength", "contact_cohesion"]  # options of graincrack.uniaxial, Pa
LEAST, MOST = [4e6, 20e6], [16e6, 90e6]


def curve_of(specimen, parameters, strains, **options):
    """Axial stress, MPa, of a uniaxial test of a specimen whose contacts have these values, at strains up to which it has a row; then the last."""
    values = {name: (float(value), "Pa") for name, value in zip(NAMES, parameters)}
    run = graincrack.uniaxial(specimen, **values, max_strain=float(strains[-1]), peak_drop="none", frames=0, **options)
    strain, order = np.unique(-run.history["axial_strain"], return_index=True)
    return np.interp(strains, strain, -run.history["axial_stress"][order] / 1e6)


def run_samples(system, specimen, **options):
    """GrainLearning's callback: a test for each sample of parameters, as many at a time as there are processors."""
    curves = graincrack.map(lambda parameters: curve_of(specimen, parameters, system.ctrl_data, **options), list(system.param_data))
    system.set_sim_data([np.array(curve, ndmin=2) for curve in curves])  # samples, observables, strains


def main():
    from grainlearning import BayesianCalibration

    strain, stress = np.loadtxt(sys.argv[1], skiprows=1, unpack=True)
    specimen = graincrack.rectangle(width="20mm", height="40mm", grains=100, material=MATERIAL)
    calibration = BayesianCalibration.from_dict({
        "num_iter": 4,
        "system": {"param_names": NAMES, "param_min": LEAST, "param_max": MOST, "num_samples": 20, "obs_names": ["stress"], "obs_data": stress,
                   "ctrl_name": "strain", "ctrl_data": strain, "sim_name": "uniaxial", "sigma_tol": 0.01,
                   "callback": lambda system, **_: run_samples(system, specimen)},
        "calibration": {"inference": {"ess_target": 0.3}, "sampling": {"max_num_components": 2}, "initial_sampling": "halton"},
        "save_fig": -1,
    })
    calibration.run()
    for name, value in zip(NAMES, calibration.get_most_prob_params()):
        print(f"{name}\t{value / 1e6:.4g} MPa")


if __name__ == "__main__":
    main()
