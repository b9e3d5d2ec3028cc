/** The logo: a blade on a line. */
export function Logo({ size = 24 }: { size?: number }) {
  return (
    <svg width={size} height={size} viewBox="0 0 32 32" aria-hidden="true">
      <path d="M5 24.5h22" stroke="#ff6b61" strokeWidth="2.4" strokeLinecap="round" />
      <path d="M11.2 4.5h9.6v10.2l-8.6 9.8-1-9.8z" fill="var(--ink-1)" />
      <path d="M11.2 4.5h9.6v4h-9.6z" fill="#3f8fff" />
    </svg>
  );
}
