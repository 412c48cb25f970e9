// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/target_argument.h"

#include <QStringList>

namespace hitscope::cli {

Result<const Target*> targetNamed(const Session& session, const QString& name) {
    constexpr qsizetype kMostNames = 10;  // that an error lists
    QStringList names;
    for (const std::unique_ptr<Target>& target : session.targets()) {
        if (target->name == name) {
            return target.get();
        }
        names << target->name;
    }
    const QString more = names.size() > kMostNames ? QStringLiteral(" and others") : QString();
    return Error{
        "There is no target named \"" + name.toStdString() + "\".", "",
        "There are: " + (names.mid(0, kMostNames).join(QStringLiteral(", ")) + more).toStdString() + "."};
}

Result<std::vector<const Target*>> targetsNamed(const Session& session, const QString& name) {
    std::vector<const Target*> found;
    if (!name.isEmpty()) {
        const Result<const Target*> target = targetNamed(session, name);
        if (!target) {
            return target.error();
        }
        return std::vector{target.value()};
    }
    for (const std::unique_ptr<Target>& target : session.targets()) {
        found.push_back(target.get());
    }
    return found;
}

}  // namespace hitscope::cli
