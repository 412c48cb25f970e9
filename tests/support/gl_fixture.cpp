// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/gl_fixture.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <QTest>

namespace hitscope::test {

bool GlFixture::open() {
    if (!epoxy_has_egl()) {
        QTest::qSkip("there is no EGL library on this machine", __FILE__, __LINE__);
        return false;
    }
    Result<std::unique_ptr<gl::OffscreenContext>> context = gl::OffscreenContext::create();
    if (!context) {
        QTest::qFail(context.error().message().c_str(), __FILE__, __LINE__);
        return false;
    }
    m_context = std::move(context).value();
    gl::collectDebugMessages();
    return true;
}

int GlFixture::mostSamples() {
    GLint samples = 0;
    glGetIntegerv(GL_MAX_SAMPLES, &samples);
    return samples;
}

QStringList GlFixture::errors() {
    QStringList errors;
    if (m_context) {
        for (const std::string& error : gl::takeErrors()) {
            errors.append(QString::fromStdString(error));
        }
    }
    return errors;
}

}  // namespace hitscope::test
