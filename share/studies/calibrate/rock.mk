# The rock of a calibration has no default.
ROCK ?=
$(if $(ROCK),,$(error ROCK is missing: the material file of your rock, as make -C share/studies calibrate ROCK=my-rock.toml OUT=results -j 2; \
    `graincrack-post material init` writes one))
