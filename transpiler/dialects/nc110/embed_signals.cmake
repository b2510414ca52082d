# Writes OUTPUT, a C++ file with the text of INPUT (signals.csv) as one constant. Run with cmake -P.
file(READ "${INPUT}" TEXT)
# Compilers limit the length of one literal; adjacent ones are joined.
string(REGEX REPLACE "(\nU10K0,)" ")csv\" R\"csv(\\1" TEXT "${TEXT}")
file(WRITE "${OUTPUT}" "#include \"transpiler/dialects/nc110/signals.h\"

namespace plcxx::nc110 {

const std::string_view kSignalTable = R\"csv(${TEXT})csv\";

}  // namespace plcxx::nc110
")
