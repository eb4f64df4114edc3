/// \file
/// Starts an invisible X server of our own if no display answers.
#pragma once

#include "core/base/error.h"
#include <QProcess>

namespace ramure::cli {

class VirtualDisplay
{
public:
    VirtualDisplay() = default;
    ~VirtualDisplay(); ///< ends the server
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;

    /// Nothing where an X server answers behind DISPLAY; else starts Xvfb and sets DISPLAY. Call before any
    /// QGuiApplication. Error: Unknown (Xvfb is missing or does not start).
    Expected<void> ensure();

private:
    QProcess m_server;
};

} // namespace ramure::cli
