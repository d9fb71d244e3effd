// The keys that files may have are those that their readers ask for.
#include "lib/scene/known_keys.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "lib/scene/material_path.hpp"
#include "lib/scene/names.hpp"
#include "lib/scene/read_scene.hpp"
#include "lib/scene/study.hpp"
#include "places.hpp"

namespace plumb {
namespace {

namespace fs = std::filesystem;

const KeyNotes& scenes() {
  static const KeyNotes notes = keys_of_scenes();
  return notes;
}
const KeyNotes& studies() {
  static const KeyNotes notes = keys_of_studies({"swinging-plate", "any-other"});
  return notes;
}
const KeyNotes& paths() {
  static const KeyNotes notes = keys_of_paths();
  return notes;
}

std::vector<std::string> toml_files_in(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry :
       fs::directory_iterator(std::string(PLUMBLINE_SOURCE_DIR "/verification/") + folder))
    if (entry.path().extension() == ".toml") files.push_back(entry.path().string());
  return files;
}

/// "study.parameters.amplitude" is one of "study.parameters.*".
const KeyNote* found(const KeyNotes& notes, const std::string& path) {
  if (const KeyNote* key = notes.find(path)) return key;
  return notes.find(path.substr(0, path.rfind('.')) + ".*");
}

/// Every value that a getter took somewhere is one that `known` says it takes.
void expect_within(const KeyNotes& asked, const KeyNotes& known, const std::string& file) {
  for (const KeyNote& key : asked.keys()) {
    const KeyNote* same = found(known, key.path);
    ASSERT_TRUE(same) << file << ": " << key.path;
    for (const ValueForm& form : key.forms) {
      const auto at = std::find_if(same->forms.begin(), same->forms.end(), [&](const ValueForm& other) {
        return other.kind == form.kind && other.quantity.dimension == form.quantity.dimension;
      });
      ASSERT_NE(at, same->forms.end()) << file << ": " << key.path;
      for (const std::string& word : form.words)
        EXPECT_NE(std::find(at->words.begin(), at->words.end(), word), at->words.end())
            << file << ": " << key.path << " = " << word;
    }
  }
}

TEST(KnownKeys, NoSceneAsksForAnother) {
  for (const std::string& file : toml_files_in("scenes")) {
    KeyNotes asked;
    scene_of(parse_document(read_text(file), file), file, &asked);
    EXPECT_GT(asked.keys().size(), 30u) << file;  // [method] alone has a dozen
    expect_within(asked, scenes(), file);
  }
}

TEST(KnownKeys, NoStudyAsksForAnother) {
  for (const std::string& file : toml_files_in("studies")) {
    const TomlValue document = parse_document(read_text(file), file);
    if (!document.find("study")) continue;
    KeyNotes asked;
    study_of(document, file, {}, StudyOf::space, &asked);
    for (const KeyNote& key : asked.keys()) {
      ASSERT_TRUE(found(studies(), key.path)) << file << ": " << key.path;
    }
  }
}

TEST(KnownKeys, NoPathAsksForAnother) {
  for (const std::string& file : toml_files_in("material")) {
    KeyNotes asked;
    material_path_of(parse_document(read_text(file), file), &asked);
    expect_within(asked, paths(), file);
  }
}

/// Each is explained at the call that reads it, and each that is asked for is read by some getter.
TEST(KnownKeys, HaveMeaningsAndReaders) {
  for (const KeyNotes* notes : {&scenes(), &studies(), &paths()})
    for (const KeyNote& key : notes->keys()) {
      EXPECT_FALSE(key.forms.empty()) << key.path;
      EXPECT_FALSE(key.meaning.empty()) << key.path;
    }
}

/// Every section was read to its end somewhere, those of schemes among them.
TEST(KnownKeys, OfSectionsAreAllFound) {
  for (const KeyNote& key : scenes().keys())
    for (const ValueForm& form : key.forms) {
      const bool one = form.kind == ValueKind::section, list = form.kind == ValueKind::sections;
      EXPECT_TRUE(!one || scenes().closed(key.path)) << key.path;
      EXPECT_TRUE(!list || scenes().closed(key.path + ".0")) << key.path;
    }
}

/// Words of choices are those of the catalogues.
TEST(KnownKeys, HaveTheWordsOfTheCatalogues) {
  const auto words = [](const std::string& path) { return scenes().find(path)->forms.front().words; };
  EXPECT_EQ(words("method.scheme"), scheme_names());
  EXPECT_EQ(words("material.model"), material_names());
  EXPECT_EQ(words("body.shape"), shape_names());
  EXPECT_EQ(words("boundary.0.kind"), boundary_kind_names());
  EXPECT_EQ(words("boundary.0.face").size(), 6u);  // in 2D four, in 1D two of them
}

/// What a getter without default asked for, in every reading; and the defaults, where there is one or more.
TEST(KnownKeys, KnowWhatIsRequiredAndDefault) {
  const auto required = [](const KeyNotes& notes, const std::string& path) {
    return notes.required(*notes.find(path));
  };
  for (const char* path :
       {"scene", "scene.dimension", "body", "material", "material.young", "material.poisson",
        "material.density", "output.probe.0.name", "output.probe.0.at", "damping.rate"})
    EXPECT_TRUE(required(scenes(), path)) << path;
  for (const char* path : {"method", "scene.end_time", "body.size", "body.spacing", "body.radius",
                           "material.yield", "boundary", "boundary.0.face", "boundary.0.velocity"})
    EXPECT_FALSE(required(scenes(), path)) << path;
  EXPECT_TRUE(required(studies(), "study.solution"));
  EXPECT_FALSE(required(paths(), "material.density"));
  EXPECT_EQ(scenes().find("jst.eta4")->otherwise, std::set<std::string>{"0.015625"});
  EXPECT_EQ(scenes().find("method.beta")->otherwise.size(), 2u);  // 0.9, and that of paper 004
  EXPECT_EQ(scenes().find("output.vtk")->otherwise, std::set<std::string>{"false"});
  EXPECT_EQ(scenes().find("implicit.steps")->forms.front().least, 1);
}

}  // namespace
}  // namespace plumb
