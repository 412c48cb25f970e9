# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(mesh_exporter LABEL widgets SOURCES mesh_exporter_test.cpp LINK hitscope_app TIMEOUT 300)
