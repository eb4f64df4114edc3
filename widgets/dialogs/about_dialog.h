/// \file
/// About: the program, and the versions that a bug report needs.
#pragma once

#include <QDialog>

namespace ramure {

class AboutDialog : public QDialog
{
    Q_OBJECT
public:
    explicit AboutDialog(QWidget* parent = nullptr);

    /// Versions as plain text, for a bug report.
    static QString versions();
};

} // namespace ramure
