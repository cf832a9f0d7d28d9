# Runs a formula for Homebrew on a machine without Homebrew: prints what it would download and install on each system.

class Formula
  SYSTEMS = [%i[macos intel], %i[macos arm], %i[linux intel], %i[linux arm]].freeze

  class << self
    attr_accessor :system

    %i[desc homepage version license].each { |word| define_method(word) { |value| puts "#{word}: #{value}" if Formula.system == SYSTEMS[0] } }
    %i[url sha256].each { |word| define_method(word) { |value| puts "#{Formula.system.join(" ")} #{word}: #{value}" } }
    %i[on_macos on_linux on_intel on_arm].each do |word|
      define_method(word) { |&block| block.call if Formula.system.include?(word.to_s.delete_prefix("on_").to_sym) }
    end
    def test(&) = nil
  end

  # Where it installs to: prints the name and what is installed there.
  %i[bin man1 bash_completion zsh_completion fish_completion doc].each do |place|
    define_method(place) { Class.new { define_singleton_method(:install) { |files| puts "#{place}: #{files}" } } }
  end
end

# What is in an archive does not matter here: a pattern stands for its files.
Dir.define_singleton_method(:[]) { |pattern| pattern }

Formula::SYSTEMS.each do |system|
  Formula.system = system
  load ARGV[0]
  Object.const_get(:LadderLogic).new.install if system == Formula::SYSTEMS[-1]
  Object.send(:remove_const, :LadderLogic)
end
