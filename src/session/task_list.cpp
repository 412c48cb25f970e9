// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/task_list.h"

#include <algorithm>
#include <utility>

namespace hitscope {

TaskList::TaskList(QObject* parent) : QObject(parent) {}

TaskList::~TaskList() = default;

TaskList::Task* TaskList::find(int id) {
    const auto found =
        std::find_if(m_tasks.begin(), m_tasks.end(), [id](const Task& task) { return task.id == id; });
    return found == m_tasks.end() ? nullptr : &*found;
}

void TaskList::cancel(int id) {
    const Task* task = find(id);
    if (task != nullptr && task->cancel) {
        const std::function<void()> stop = task->cancel;  // it may end the task
        stop();
    }
}

TaskProgress::TaskProgress(TaskList& list, const QString& what, std::function<void()> cancel,
                           const QString& cancelHelp)
    : m_list(list), m_id(list.m_nextId++) {
    list.m_tasks.push_back({m_id, what, -1.0, std::move(cancel), cancelHelp});
    Q_EMIT list.changed();
}

TaskProgress::~TaskProgress() {
    m_list.m_tasks.remove_if([this](const TaskList::Task& task) { return task.id == m_id; });
    Q_EMIT m_list.changed();
}

void TaskProgress::report(double fraction) {
    TaskList::Task* task = m_list.find(m_id);
    if (task != nullptr && task->fraction != fraction) {
        task->fraction = fraction;
        Q_EMIT m_list.changed();
    }
}

void TaskProgress::say(const QString& what) {
    TaskList::Task* task = m_list.find(m_id);
    if (task != nullptr && task->what != what) {
        task->what = what;
        Q_EMIT m_list.changed();
    }
}

}  // namespace hitscope
