// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <vector>

#include "core/result.h"
#include "deform/deformation_constants.h"
#include "deform/dent_form.h"

class QSettings;

namespace hitscope {

struct ConstantsPreset {
    QString name;
    DeformationConstants constants;
    std::optional<DentForm> form;  ///< without a radius; nothing: any
    bool isOurs = false;           ///< came with the program: always there

    /// Whether a dent of these constants and this form is as the preset has it.
    [[nodiscard]] bool holdsFor(const DentForm& given) const;
};

/// Deformation constants and forms of dents under a name: ours first, then those people saved, by name.
class ConstantsPresets {
public:
    ConstantsPresets();

    [[nodiscard]] const std::vector<ConstantsPreset>& all() const { return m_presets; }
    /// The first of these constants, and of this form or any; nothing: they are nobody's.
    [[nodiscard]] std::optional<std::size_t> find(const DeformationConstants& constants,
                                                  const DentForm& form) const;
    /// Under a new name, or in place of a saved one of that name. Refused for an empty name and one of ours.
    [[nodiscard]] Status save(const QString& name, const DeformationConstants& constants,
                              const DentForm& form);
    void remove(const QString& name);  ///< ours stay

    /// What is not a preset within the ranges is passed over.
    void load(QSettings& settings);
    void store(QSettings& settings) const;

private:
    std::vector<ConstantsPreset> m_presets;
};

}  // namespace hitscope
