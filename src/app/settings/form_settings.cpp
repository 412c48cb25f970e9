// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/form_settings.h"

#include <QSettings>

#include "deform/dent_form_text.h"

namespace hitscope {

DentForm loadForm(const QSettings& settings) {
    const auto text = [&settings](const char* key) {
        return settings.value(QLatin1String(key)).toString().toStdString();
    };
    DentForm form;
    form.profile = profileNamed(text("constants/profile")).value_or(form.profile);
    form.direction = directionNamed(text("constants/direction")).value_or(form.direction);
    form.curve = curveFrom(text("constants/curve"), ' ').value_or(form.curve);
    return form;
}

void saveForm(QSettings& settings, const DentForm& form) {
    const auto save = [&settings](const char* key, std::string_view text) {
        settings.setValue(QLatin1String(key),
                          QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())));
    };
    save("constants/profile", keyOf(form.profile));
    save("constants/direction", keyOf(form.direction));
    save("constants/curve", curveText(form.curve, ' '));
}

}  // namespace hitscope
