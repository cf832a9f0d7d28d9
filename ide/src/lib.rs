//! What an editor asks of ladder text, without a protocol.
