// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// QCustomPlot's header speaks with Qt's keywords, which mean nothing in ours.
#define emit
#define foreach Q_FOREACH
#define signals Q_SIGNALS
#define slots Q_SLOTS
#include <qcustomplot.h>
#undef emit
#undef foreach
#undef signals
#undef slots
