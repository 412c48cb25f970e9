// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QPointer>
#include <new>
#include <utility>

#include "analysis/background_pool.h"

namespace hitscope {

/// Calls work() on a thread of backgroundPool(), then then(Owner& owner, bool done) on the application's; not
/// done: there was no memory for it. `owner` lives on that thread; once it is gone nobody is told. What both
/// share they hold by shared pointers.
template <typename Owner, typename Work, typename Then>
void workBeside(Owner* owner, Work work, Then then) {
    startInBackground(
        [owner = QPointer<Owner>(owner), work = std::move(work), then = std::move(then)]() mutable {
            bool done = true;
            try {
                work();
            } catch (const std::bad_alloc&) {
                done = false;
            }
            // By way of the application: the owner may go while it is being told.
            QMetaObject::invokeMethod(
                QCoreApplication::instance(),
                [owner, then = std::move(then), done]() mutable {
                    if (Owner* alive = owner.data(); alive != nullptr) {
                        then(*alive, done);
                    }
                },
                Qt::QueuedConnection);
        });
}

}  // namespace hitscope
