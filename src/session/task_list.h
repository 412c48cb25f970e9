// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <list>
#include <optional>

namespace hitscope {

/// What takes a while at the moment: an import, an export, the hits being applied again. Whoever does such a
/// thing holds a TaskProgress while it lasts; the status bar shows them. Of the window's thread; who works on
/// another reports through it.
class TaskList : public QObject {
    Q_OBJECT
public:
    explicit TaskList(QObject* parent = nullptr);
    ~TaskList() override;

    struct Task {
        int id = 0;
        QString what;                  ///< "Opening teapot.obj"
        double fraction = -1.0;        ///< [0, 1]; negative: not known
        std::function<void()> cancel;  ///< empty: it cannot be
        QString cancelHelp;            ///< what is then
    };
    /// The one that was begun first; null: nothing is going on.
    [[nodiscard]] const Task* current() const { return m_tasks.empty() ? nullptr : &m_tasks.front(); }
    [[nodiscard]] std::size_t size() const { return m_tasks.size(); }
    /// Asks the task to stop; it then ends in its own time. Ids of none are passed over.
    void cancel(int id);

Q_SIGNALS:
    void changed();

private:
    friend class TaskProgress;
    [[nodiscard]] Task* find(int id);

    std::list<Task> m_tasks;
    int m_nextId = 1;
};

/// A task in a TaskList, from its making to its end.
class TaskProgress {
public:
    /// `list` outlives this.
    TaskProgress(TaskList& list, const QString& what, std::function<void()> cancel = {},
                 const QString& cancelHelp = {});
    ~TaskProgress();
    TaskProgress(const TaskProgress&) = delete;
    TaskProgress& operator=(const TaskProgress&) = delete;

    /// fraction in [0, 1]; negative: not known.
    void report(double fraction);
    void say(const QString& what);

private:
    TaskList& m_list;
    int m_id;
};

}  // namespace hitscope
