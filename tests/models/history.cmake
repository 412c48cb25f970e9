# SPDX-License-Identifier: GPL-3.0-or-later
hitscope_test(hit_list LABEL models SOURCES hit_list_test.cpp LINK hitscope_models)
