#include "lib/input/document.hpp"

#include <gtest/gtest.h>

#include "lib/core/error.hpp"

namespace plumb {
namespace {

const char* const file = R"(title = "a"
[body]
size = [1, 2.5]
spacing = 0.1
flag = true
[[boundary]]
kind = "clamped"
[[boundary]]
kind = "roller"
)";

std::map<std::string, std::string> settings(const std::vector<std::string>& overrides) {
  return settings_of(parse_document(file, "a.toml", overrides, {{"body.spacing", "body.particles"}}));
}

TEST(Document, EveryKindOfValueIsReadWithItsLine) {
  const TomlValue root = parse_document(file, "a.toml");
  EXPECT_EQ(root.find("title")->text, "a");
  const TomlValue& body = *root.find("body");
  EXPECT_EQ(body.names, (std::vector<std::string>{"size", "spacing", "flag"}));
  EXPECT_EQ(body.find("size")->items[0].whole, 1);
  EXPECT_EQ(body.find("size")->items[0].number, 1.0);
  EXPECT_EQ(body.find("size")->items[1].number, 2.5);
  EXPECT_EQ(body.find("spacing")->where.line, 4);
  EXPECT_TRUE(body.find("flag")->flag);
  EXPECT_EQ(root.find("boundary")->items[1].find("kind")->text, "roller");
  EXPECT_EQ(root.find("absent"), nullptr);
}

struct Override {
  std::string change, key, value;
};

TEST(Document, OverridesGiveTheirValues) {
  for (const Override& row :
       {Override{"body.spacing=0.2", "body.spacing", "0.20000000000000001"},
        Override{"body.spacing=.25", "body.spacing", "0.25"},
        Override{"body.spacing=5.", "body.spacing", "5"},
        Override{"body.spacing=-.5e3", "body.spacing", "-500"},
        Override{"method.paper=004", "method.paper", "\"004\""},
        Override{"body.spacing = 5 mm", "body.spacing", "\"5 mm\""},
        Override{"body.size=[3,4]", "body.size.1", "4"}, Override{"body.size.0=7", "body.size.0", "7"},
        Override{"boundary.1.kind=clamped", "boundary.1.kind", "\"clamped\""},
        Override{"new.key=false", "new.key", "false"}, Override{"body.flag=false", "body.flag", "false"}})
    EXPECT_EQ(settings({row.change}).at(row.key), row.value) << row.change;
  EXPECT_FALSE(settings({"body.particles=[3,3]"}).contains("body.spacing")) << "one of two alternatives";
  EXPECT_EQ(settings({"body.spacing=0.2", "body.spacing=0.3"}).at("body.spacing"), "0.29999999999999999");
}

TEST(Document, SettingsAreThoseOfTheFile) {
  const std::map<std::string, std::string> right{{"title", "\"a\""},
                                                 {"body.size.0", "1"},
                                                 {"body.size.1", "2.5"},
                                                 {"body.spacing", "0.10000000000000001"},
                                                 {"body.flag", "true"},
                                                 {"boundary.0.kind", "\"clamped\""},
                                                 {"boundary.1.kind", "\"roller\""}};
  EXPECT_EQ(settings({}), right);
}

struct Slip {
  std::string text, change, message;
};

TEST(Document, SlipsGetTheRightHint) {
  for (const Slip& slip :
       {Slip{file, "boundary.kind=roller",
             "--set: boundary.kind: no item \"kind\". The scene has 2 there, counted from 0. Write "
             "boundary.0.kind."},
        Slip{file, "boundary.7.kind=roller",
             "--set: boundary.7.kind: no item \"7\". The scene has 2 there, counted from 0."},
        Slip{file, "title.a=1",
             "--set: title.a: \"title\" is not a section. It is the string \"a\" at a.toml:1."},
        Slip{file, "title",
             "--set: \"title\" is not an override. It must read section.key=value. Write for example --set "
             "material.young=\"17 MPa\"."}})
    try {
      parse_document(slip.text, "a.toml", {slip.change});
      ADD_FAILURE() << slip.change << " is accepted";
    } catch (const SceneError& error) {
      EXPECT_EQ(error.what(), slip.message);
    }
}

TEST(Document, ADecimalCommaInTheFileIsNamed) {
  try {
    parse_document("[body]\nspacing = 0,5\n", "a.toml");
    ADD_FAILURE() << "accepted";
  } catch (const SceneError& error) {
    EXPECT_EQ(error.suggestion(), "decimals follow a point: write 0.5");
    EXPECT_EQ(error.where().line, 2);
  }
}

}  // namespace
}  // namespace plumb
