# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(projectile_dialog LABEL widgets SOURCES projectile_dialog_test.cpp LINK hitscope_app TIMEOUT 300)
