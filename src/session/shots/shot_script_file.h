// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>

#include "core/result.h"
#include "session/shots/shot_script.h"

namespace hitscope {

/// A script as JSON: {"hitscope-shots": 1, "instant": false, "projectile": {"speed": 30, ...}, "shots":
/// [{"time": 0, "from": [x, y, z], "direction": [x, y, z]}, ...]}, and where the form of the dents is the
/// script's "dent": {"profile": "curve", "direction": "projectile", "curve": [1, ... 0]}. Seconds, metres,
/// world. What is read back is equal in every bit.
[[nodiscard]] QByteArray formatShotScript(const ShotScript& script);
/// The error says which member is wrong, and what it has to be: unknown members, wrong types, numbers out of
/// range, shots that are not in the order of their times, more than ShotScript::kMostShots. Directions are
/// made unit. What "projectile" leaves out is as by default.
[[nodiscard]] Result<ShotScript> parseShotScript(const QByteArray& json);

/// parseShotScript() of a regular file, which the error names.
[[nodiscard]] Result<ShotScript> readShotScript(const QString& path);
/// Whole or not at all.
[[nodiscard]] Status writeShotScript(const ShotScript& script, const QString& path);

}  // namespace hitscope
