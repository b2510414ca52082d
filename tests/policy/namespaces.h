// Rules about names that the linker cannot check: a type is defined once, and a folder has a namespace of its own.
//
// In: a root with sources below transpiler/, and tests/policy/namespaces.txt. Out: findings. Two classes with one
// qualified name link without a message and share destructors and vtables; only a look at all sources together sees
// them.
#pragma once

#include <string>

#include "tests/policy/repository.h"

namespace plcxx::policy {

/// Classes, structs, unions and enums that are defined twice under one qualified name, at namespace scope and outside
/// of namespaces without a name. A pattern that finds no definition at all is a finding, too.
Findings CheckDefinedOnce(const std::string& root);

/// Functions of namespaces without a name that two files of one namespace have under one name, whatever their
/// parameters: files are compiled together, and a call may mean the other file's. Files that stand alone
/// (plcxx_alone in a CMakeLists.txt) may.
Findings CheckLocalFunctions(const std::string& root);

/// Files that open another namespace than namespaces.txt gives their folder (or the next one above it), folders
/// without, rows without files, and namespaces that two rows share.
Findings CheckFolderNamespaces(const std::string& root);

}  // namespace plcxx::policy
