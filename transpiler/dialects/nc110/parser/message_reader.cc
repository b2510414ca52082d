#include "transpiler/dialects/nc110/parser/message_reader.h"

namespace plcxx::nc110 {

constexpr uint32_t kMaxMessage = 255;
constexpr size_t kMaxMessageText = 42;

void MessageReader::ParseMessage(Item& item) {
  const Token& word = Take();
  CheckCase(word);
  Message message;
  if (!At(TokenKind::kNumber) || Peek().first_on_line) {
    // A declaration ends with its line.
    Fault(Peek().first_on_line ? BehindPrevious() : MissingAt(), diag::Nc110MsgNumberMissing, Found());
  } else {
    const ConstantUse number = operands_.TakeConstant();
    if (number.well_formed && (number.value < 1 || number.value > kMaxMessage)) {
      Fault(number.range, diag::Nc110MsgNumberRange, number.text);
    } else if (number.well_formed) {
      message.number = static_cast<uint16_t>(number.value);
      const MessageId first = messages_by_number_[message.number];
      if (first.valid()) {
        Fault(number.range, diag::Nc110MsgTwice, static_cast<diag::Number>(message.number))
            .notes.push_back({program_.messages[first].text, "the first declaration"});
        message.number = 0;
      }
    }
    if (At(TokenKind::kAssign) && !Peek().first_on_line) {
      Take();
    }
  }
  if (At(TokenKind::kMsgText)) {
    const Token& text = Take();
    message.text = text.range;
    if (TextOf(text).starts_with('"') && !text.faulty) {
      message.text = {text.range.begin + 1, text.range.end - 1};
    }
  }
  const size_t length = source::CountCodePoints(Plain(message.text));
  if (length == 0) {
    Fault(BehindPrevious(), diag::Nc110MsgTextMissing);
  } else if (length > kMaxMessageText) {
    Fault(message.text, diag::Nc110MsgTextTooLong, static_cast<diag::Number>(length));
  }
  Warn(word.range, diag::Nc110MsgLegacy);
  item.kind = ItemKind::kMessage;
  const MessageId id = program_.messages.Add(message);
  item.detail = id.index;
  if (message.number != 0) {
    messages_by_number_[message.number] = id;
  }
}

}  // namespace plcxx::nc110
