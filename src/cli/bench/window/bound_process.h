// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QProcess>

namespace hitscope::bench {

/// It is asked to end when this program ends, however that ends. Before it is started.
void bindToThis(QProcess& process);

}  // namespace hitscope::bench
